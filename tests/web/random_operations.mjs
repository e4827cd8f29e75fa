// Random operation files: two triangulations of one polygon, with vertices inside.

/// `random(n)`: a number below n.
export function randomOperation(random, name) {
  const corners = 3 + random(4);
  const outline = Array.from({ length: corners }, (_, i) => `p${i}`);
  const side = (letter) => {
    const triangles = [];
    const cut = (polygon) => {
      if (polygon.length < 3) return;
      if (polygon.length === 3) return void triangles.push(polygon);
      const tip = 1 + random(polygon.length - 2);
      triangles.push([polygon[0], polygon[tip], polygon.at(-1)]);
      cut(polygon.slice(0, tip + 1));
      cut(polygon.slice(tip));
    };
    cut(outline);
    for (let inside = random(3); inside > 0 && triangles.length < 5; --inside) {
      const [[a, b, c]] = triangles.splice(random(triangles.length), 1);
      const m = `${letter}${inside}`;
      triangles.push([a, b, m], [b, c, m], [c, a, m]);
    }
    return triangles.map((triangle) => {
      const turn = random(3);
      return [...triangle.slice(turn), ...triangle.slice(0, turn)];
    });
  };
  const constraint = ['strips', 'strips', 'strips', 'matching'][random(4)];
  const operation = { restrip_operation: 1, name, about: 'Two triangulations of a polygon.', constraint, before: side('b'), after: side('a'),
    give_up: constraint === 'matching' ? 'all' : ['none', 'all', [random(corners)]][random(3)] };
  if (random(5) === 0) operation.cost = [[{ count: 'strips' }], [{ count: 'ends', weight: 2 }, { count: 'given_up' }], [{ count: 'solid', edges: [0] }]];
  if (random(6) === 0) {
    // Of a side without inner vertices any edge of the outline may be the mesh's boundary.
    operation.boundary = [['p0', 'p1']];
    if (Array.isArray(operation.give_up)) operation.give_up = 'none';
  }
  return operation;
}
