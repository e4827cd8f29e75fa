/* restrip for C: maintains triangle strips while a mesh changes, by proven rules.
 *
 * This header is plain C99 and needs no other file of restrip. Link the shared or the static library restrip_c (CMake:
 * restrip::c, restrip::c_static; pkg-config: restrip-c). docs/how-to/c.md is the guide, examples/keep_strips.c a whole
 * program.
 *
 *   restrip_mesh *mesh;
 *   restrip_status status = restrip_mesh_build_u32(indices, index_count, vertex_count, NULL, NULL, &mesh);
 *   if (status != RESTRIP_OK) return puts(restrip_describe(status));
 *   restrip_mesh_stripify(mesh, RESTRIP_EFFORT_FULL, NULL, 0, NULL);
 *   restrip_mesh_collapse(mesh, restrip_mesh_find(mesh, 4, 7), NULL);
 *   restrip_mesh_free(mesh);
 *
 * Words. Two triangles that share a mesh edge are joined by a dual edge, which is solid (one strip passes over it) or
 * dashed. A colouring is valid when each triangle has at most two solid dual edges and none of them close a cycle; the
 * strips are then the paths of solid edges. Every mesh here has a valid colouring at every moment.
 *
 * Errors. Every function that can fail returns a restrip_status: RESTRIP_OK is 0, everything else says why nothing was
 * done. Results are written through pointers, and only with RESTRIP_OK, unless the comment of the function says
 * otherwise. No exception leaves the library, nothing is printed, and the program is never ended. A null pointer that
 * is not allowed gives RESTRIP_NULL_ARGUMENT. A pointer to a freed mesh, or an array shorter than its stated size,
 * cannot be detected.
 *
 * Threads. Different meshes may be used by different threads at once. One mesh may be read by several threads
 * (functions that take a const restrip_mesh *), or be changed by one. The library has no other state.
 *
 * Complexities are given for T triangles. Memory: 24 bytes a triangle and 5 a vertex; 20 more a triangle under
 * RESTRIP_POLICY_QUICK and RESTRIP_POLICY_FULL for fewest strips; and the contents of a live
 * buffer or a baked mesh.
 */
#ifndef RESTRIP_H
#define RESTRIP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define RESTRIP_API __attribute__((visibility("default")))
#else
#define RESTRIP_API
#endif

/* ---- Version ----------------------------------------------------------------------------------- */

/* The number of this interface. It is part of the name of the shared library (librestrip_c.so.4) and increases when a
 * program compiled with an older header can no longer use the library. New functions and new codes do not change it. */
#define RESTRIP_ABI_VERSION 4

/* RESTRIP_ABI_VERSION of the compiled library: for programs that load it at run time. */
RESTRIP_API uint32_t restrip_abi_version(void);
/* Version of restrip, such as "1.0.0". */
RESTRIP_API const char* restrip_version(void);

/* ---- Errors ------------------------------------------------------------------------------------ */

typedef int32_t restrip_status;
enum {
  RESTRIP_OK = 0,

  /* Why an operation on the mesh is refused. */
  RESTRIP_NO_SUCH_EDGE = 1,        /* the halfedge is not one of the mesh */
  RESTRIP_DIFFERENT_VERTICES = 2,  /* the two spokes of a split do not leave the same vertex */
  RESTRIP_SAME_SPOKE = 3,          /* the two spokes of a split are the same */
  RESTRIP_NON_MANIFOLD_VERTEX = 4, /* the mesh is not manifold at a vertex of the operation */
  RESTRIP_BOUNDARY_EDGE = 5,       /* a flip needs a triangle on both sides */
  RESTRIP_SPOKE_ON_BOUNDARY = 6,   /* a split with one spoke needs a vertex on the boundary */
  RESTRIP_JOINS_BOUNDARIES = 7,    /* an interior edge between two boundary vertices cannot be collapsed */
  RESTRIP_LINK_CONDITION = 8,      /* the collapse would fold the mesh: its ends have another common neighbour */
  RESTRIP_TOO_FEW_TRIANGLES = 9,   /* fewer than three triangles would remain around a vertex */
  RESTRIP_DANGLING_EDGE = 10,      /* a triangle at the collapsed edge has no other neighbour */
  RESTRIP_EDGE_EXISTS = 11,        /* an edge that the operation would make is in the mesh already */
  RESTRIP_VERTEX_IN_USE = 12,      /* the vertex named for a split has triangles already */
  RESTRIP_NO_MANIFOLD = 13,        /* the mesh would not be a manifold */
  RESTRIP_VERTEX_TOO_FAR = 14,     /* the vertex named for a split is more than 2^20 beyond all others */
  RESTRIP_OTHER_PATCH = 15,        /* the triangles there differ from the custom operation's */
  RESTRIP_SAME_VERTEX = 16,        /* two vertices of the custom operation are one vertex of the mesh */

  /* Everything else. */
  RESTRIP_NULL_ARGUMENT = 100, /* a pointer that must not be null is null */
  RESTRIP_BAD_ARGUMENT = 101,  /* outside its range, or not supported here: see the function */
  RESTRIP_BAD_COLORING = 102,  /* the colours given are not a valid colouring */
  RESTRIP_TOO_LARGE = 103,     /* more than a mesh can hold, or a vertex that 16-bit indices cannot name */
  RESTRIP_TOO_SMALL = 104,     /* the array given is too short */
  RESTRIP_BAD_FILE = 105,      /* the bytes are not a saved or baked mesh, or a damaged one */
  RESTRIP_NOT_BAKED = 106,     /* the mesh was not read from a baked mesh */
  RESTRIP_OUT_OF_STEP = 107,   /* the mesh has left its baked levels; see restrip_baked_restart */
  RESTRIP_OUT_OF_MEMORY = 108,
  RESTRIP_UNEXPECTED = 109 /* an error in the library */
};

/* One human-readable sentence, in English. Never null, for any number. The text is constant. */
RESTRIP_API const char* restrip_describe(restrip_status status);

/* ---- A mesh ------------------------------------------------------------------------------------ */

/* Triangles with coloured dual edges, and the policy that maintains the strips. */
typedef struct restrip_mesh restrip_mesh;

/* No vertex, no triangle, no halfedge. */
#define RESTRIP_NONE UINT32_C(0xFFFFFFFF)

/* A report on the triangles given. Nothing is repaired: every triangle is in the mesh or counted as left out. */
typedef struct restrip_build_report {
  size_t degenerate_triangles;   /* left out: a corner twice */
  size_t out_of_range_triangles; /* left out: a corner that is not a vertex */
  size_t boundary_edges;         /* edges of one triangle */
  size_t non_manifold_edges;     /* edges of three triangles or more; strips cross them in pairs */
  size_t inconsistent_edges;     /* edges of two triangles that disagree in orientation: no strip crosses them */
  size_t non_manifold_vertices;  /* operations refuse them */
} restrip_build_report;

/* Makes a mesh of an index array: three corners for each triangle, counter-clockwise, below vertex_count. All dual
 * edges are dashed, and the policy is RESTRIP_POLICY_QUICK for RESTRIP_FEWEST_INDICES. `report` may be null. `origin`
 * may be null, or has room for index_count / 3 numbers and receives for each triangle of the mesh its place in
 * `indices` (they differ when some are left out). The indices are copied. index_count must be a multiple of 3 (else
 * RESTRIP_BAD_ARGUMENT); a mesh holds at most 536,870,911 triangles and the same number of vertices
 * (else RESTRIP_TOO_LARGE), and has memory for all vertices below vertex_count. O(T). Release the mesh with
 * restrip_mesh_free. After an error *mesh is null. */
RESTRIP_API restrip_status restrip_mesh_build_u32(const uint32_t* indices, size_t index_count, size_t vertex_count,
                                                  restrip_build_report* report, uint32_t* origin, restrip_mesh** mesh);
RESTRIP_API restrip_status restrip_mesh_build_u16(const uint16_t* indices, size_t index_count, size_t vertex_count,
                                                  restrip_build_report* report, uint32_t* origin, restrip_mesh** mesh);
/* A mesh of the same triangles, with their numbers and colours, under the default policy. It has no live buffer yet and
 * is not baked. After an error *copy is null. O(T). */
RESTRIP_API restrip_status restrip_mesh_copy(const restrip_mesh* mesh, restrip_mesh** copy);
/* Makes room for a mesh of this size, also in the live buffer: `room` of restrip_live_buffer is then enough for it. */
RESTRIP_API restrip_status restrip_mesh_reserve(restrip_mesh* mesh, size_t triangles, size_t vertices);
/* Frees the mesh and all arrays that it returned. Null is allowed. */
RESTRIP_API void restrip_mesh_free(restrip_mesh* mesh);

/* Save and load: triangles, numbers, halfedges, colours, policy, cost and format, as bytes, the same on every machine.
 * The loaded mesh begins its buffer and its searches again. The history is not saved, nor the levels of a baked mesh.
 * *bytes is valid until the mesh is saved again. O(T): 13 bytes a triangle, and a bit for each number. */
RESTRIP_API restrip_status restrip_mesh_save(restrip_mesh* mesh, const void** bytes, size_t* size);
/* RESTRIP_BAD_FILE for bytes that are truncated, altered, of another version, or that describe what no mesh can be;
 * then `text` receives which, cut off after text_size - 1 bytes; it may be null with text_size 0. Bytes from an
 * untrusted source are safe. `history` is as in restrip_live_begin. Copy the whole restrip_live_buffer to the device.
 * After an error *mesh is null. Linear in the bytes. */
RESTRIP_API restrip_status restrip_mesh_load(const void* bytes, size_t size, size_t history, char* text,
                                             size_t text_size, restrip_mesh** mesh);

/* Triangles; 0 for a null mesh. */
RESTRIP_API size_t restrip_mesh_triangle_count(const restrip_mesh* mesh);
/* Upper bounds: all triangle and vertex numbers are below them. A triangle keeps its number until it is removed; then
 * the next triangle inserted takes it. */
RESTRIP_API size_t restrip_mesh_triangle_bound(const restrip_mesh* mesh);
RESTRIP_API size_t restrip_mesh_vertex_bound(const restrip_mesh* mesh);
/* The corners of triangle t, counter-clockwise. RESTRIP_BAD_ARGUMENT when it does not exist. */
RESTRIP_API restrip_status restrip_mesh_corners(const restrip_mesh* mesh, uint32_t t, uint32_t corners[3]);
/* The corners of all triangles, in the order of their numbers: an array with room for three numbers each (else
 * RESTRIP_TOO_SMALL). O(T). */
RESTRIP_API restrip_status restrip_mesh_triangles(const restrip_mesh* mesh, uint32_t* corners, size_t size);

/* ---- Halfedges --------------------------------------------------------------------------------- */

/* A directed mesh edge; its triangle lies to its left. Side s of triangle t, 4 t + s, runs from corner s to corner s
 * + 1. Numbers from 2^31 on name halfedges without a triangle, on the boundary. Halfedges of triangles that an
 * operation does not remove stay valid. */
typedef uint32_t restrip_halfedge;

/* The halfedge from vertex v to vertex w, or RESTRIP_NONE. O(valence of v). */
RESTRIP_API restrip_halfedge restrip_mesh_find(const restrip_mesh* mesh, uint32_t v, uint32_t w);
/* found[i] = restrip_mesh_find(mesh, v[i], w[i]) for i below n. */
RESTRIP_API restrip_status restrip_mesh_find_each(const restrip_mesh* mesh, size_t n, const uint32_t* v,
                                                  const uint32_t* w, restrip_halfedge* found);
/* A halfedge that leaves v, or RESTRIP_NONE. On the boundary it is the one from which turning counter-clockwise
 * (opposite of next of next) meets all triangles of v. O(1), like the functions below. */
RESTRIP_API restrip_halfedge restrip_mesh_spoke(const restrip_mesh* mesh, uint32_t v);
/* RESTRIP_NONE for a number that is not a halfedge of the mesh, and for `next` of a halfedge without a triangle. */
RESTRIP_API restrip_halfedge restrip_mesh_next(const restrip_mesh* mesh, restrip_halfedge h);
RESTRIP_API restrip_halfedge restrip_mesh_opposite(const restrip_mesh* mesh, restrip_halfedge h);
RESTRIP_API uint32_t restrip_mesh_from(const restrip_mesh* mesh, restrip_halfedge h);
RESTRIP_API uint32_t restrip_mesh_to(const restrip_mesh* mesh, restrip_halfedge h);
/* RESTRIP_NONE on the boundary. */
RESTRIP_API uint32_t restrip_mesh_triangle(const restrip_mesh* mesh, restrip_halfedge h);
/* 1 when the dual edge across h is solid, else 0. */
RESTRIP_API int restrip_mesh_solid(const restrip_mesh* mesh, restrip_halfedge h);

/* ---- Colours ----------------------------------------------------------------------------------- */

/* Writes the colours of all triangles: bit s of byte t is set when the dual edge over side s of triangle t is solid.
 * The array has restrip_mesh_triangle_bound bytes. O(T). */
RESTRIP_API restrip_status restrip_mesh_get_colors(const restrip_mesh* mesh, uint8_t* solid_sides, size_t size);
/* Sets all colours. They must be a valid colouring, with 0 for numbers that are not triangles (else
 * RESTRIP_BAD_COLORING), and `size` must be the bound (else RESTRIP_BAD_ARGUMENT). O(T). */
RESTRIP_API restrip_status restrip_mesh_set_colors(restrip_mesh* mesh, const uint8_t* solid_sides, size_t size);

/* A colouring counted from its definition. */
typedef struct restrip_coloring {
  size_t triangles;
  size_t strips;   /* isolated triangles included */
  size_t isolated; /* triangles without a solid edge */
  int32_t valid;   /* 1; anything else is an error in the library */
} restrip_coloring;
/* Counts the whole mesh. Close to O(T). */
RESTRIP_API restrip_status restrip_mesh_check(const restrip_mesh* mesh, restrip_coloring* coloring);
/* The number of strips, which is kept up to date: O(1), or O(T) after RESTRIP_OUT_OF_MEMORY. */
RESTRIP_API restrip_status restrip_mesh_strip_count(const restrip_mesh* mesh, size_t* strips);

/* A cost: restart * strips + swap * swaps + isolated * isolated triangles. A swap is a place where a strip turns twice
 * the same way and its index buffer repeats an index. A null cost means RESTRIP_FEWEST_INDICES. restart is 1 to 1000,
 * the others 0 to 1000 (else RESTRIP_BAD_ARGUMENT). */
typedef struct restrip_cost {
  uint16_t restart;
  uint16_t swap;
  uint16_t isolated;
} restrip_cost;
/* Initialisers. */
#define RESTRIP_FEWEST_STRIPS \
  { 1, 0, 0 }
#define RESTRIP_FEWEST_INDICES \
  { 3, 1, 0 }

/* Efforts of restrip_mesh_stripify, in the order of their running times. */
enum {
  RESTRIP_EFFORT_FAST = 0, /* one pass, O(T) */
  RESTRIP_EFFORT_FULL = 1, /* some 10 microseconds a triangle */
  RESTRIP_EFFORT_BEST = 2  /* up to ten times as long */
};
/* Strips from scratch. The result depends only on the mesh and the arguments. `limit` bounds the work of the slower
 * efforts, in searched states of a few hundred nanoseconds (fewest strips) or tried moves of some 80 ns; 0: 40 or 100
 * for each triangle. `strips` may be null, or receives their number. The next update of the live buffer rewrites it;
 * undo restores the colours. After RESTRIP_OUT_OF_MEMORY the colours are valid, but may have changed. */
RESTRIP_API restrip_status restrip_mesh_stripify(restrip_mesh* mesh, int32_t effort, const restrip_cost* cost,
                                                 uint64_t limit, size_t* strips);
/* The same. `stop` is called several times a second by the efforts above RESTRIP_EFFORT_FAST, with `context`, from the
 * thread of the call; once it returns another number than 0, the search ends with the best strips that it has found. It
 * must not use the mesh. Null: never. */
RESTRIP_API restrip_status restrip_mesh_stripify_until(restrip_mesh* mesh, int32_t effort, const restrip_cost* cost,
                                                       uint64_t limit, int32_t (*stop)(void* context), void* context,
                                                       size_t* strips);

/* ---- Operations -------------------------------------------------------------------------------- */

/* Policies: the steps after the rule of an operation, for RESTRIP_FEWEST_INDICES, and the time of all, relative to the
 * mesh update alone. README.md explains the words. */
enum {
  RESTRIP_POLICY_BARE = 0,   /* no rule, dual edges of changed triangles become dashed; 1 */
  RESTRIP_POLICY_RULES = 1,  /* nothing; 1.9 to 2.4 */
  RESTRIP_POLICY_LOCAL = 2,  /* 3 looks at the strip ends of the patch; 2.6 to 7.3 */
  RESTRIP_POLICY_QUICK = 3,  /* 10 looks, chains of 8 moves; 15 to 61 */
  RESTRIP_POLICY_FULL = 4,   /* 70 looks, around the patch as well; 49 to 290 */
  RESTRIP_POLICY_BAKED = 255 /* of restrip_baked_read: plays stored strips; restrip_mesh_keep refuses it */
};
/* From now on operations maintain the strips by this policy, for this cost (docs/reference/policies.md has figures). A
 * baked mesh leaves its levels. O(T). After an error the policy is unchanged. */
RESTRIP_API restrip_status restrip_mesh_keep(restrip_mesh* mesh, int32_t policy, const restrip_cost* cost);
/* The policy in use; RESTRIP_POLICY_BARE for a null mesh. */
RESTRIP_API int32_t restrip_mesh_policy(const restrip_mesh* mesh);

/* The result of an operation. */
typedef struct restrip_change {
  restrip_halfedge halfedge; /* split: v_s -> v_t; collapse: from v_s to v_l, or else to v_r; flip: the
                                turned edge */
  uint32_t valence;          /* of the patch; 0 under RESTRIP_POLICY_BARE */
  int32_t strips;            /* change in the number of strips of the mesh */
  int32_t isolated;          /* change in the number of isolated triangles of the mesh */
} restrip_change;

/* The operations of a dynamic mesh. Each is checked: an operation that would spoil the mesh is refused by one of
 * the codes 1 to 16 and changes nothing. `change` may be null. O(valence), and the time of the policy. After
 * RESTRIP_OUT_OF_MEMORY the operation may or may not have been done (compare restrip_mesh_triangle_count); mesh and
 * colours are valid.
 *
 * Split: v_s, which the spokes `left` = v_s -> v_l and `right` = v_s -> v_r leave, becomes v_s and v_t with a mesh edge
 * between them, and two triangles (v_s, v_t, v_l) and (v_t, v_s, v_r) are inserted. v_t takes the triangles met when
 * turning counter-clockwise from `right` to `left`. On the boundary one spoke may be RESTRIP_NONE: then the new mesh
 * edge lies on the boundary, one triangle is inserted, and v_t takes the triangles clockwise of `left`, or
 * counter-clockwise of `right`. `v_t` is the number of the new vertex, or RESTRIP_NONE for the next free one; vertices
 * up to it are allocated, 5 bytes each. */
RESTRIP_API restrip_status restrip_mesh_split(restrip_mesh* mesh, restrip_halfedge left, restrip_halfedge right,
                                              uint32_t v_t, restrip_change* change);
/* Collapse: removes the mesh edge of v_s -> v_t and the triangles at it; v_s takes the other triangles of v_t. */
RESTRIP_API restrip_status restrip_mesh_collapse(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);
/* Flip: the two triangles at the mesh edge become the two with the other diagonal. */
RESTRIP_API restrip_status restrip_mesh_flip(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);
/* The same by vertices, for programs with another mesh next to this one: the edge from v to w, of which a collapse
 * removes w; the edges from v to `left` and `right`, of which one may be RESTRIP_NONE on the boundary. */
RESTRIP_API restrip_status restrip_mesh_split_at(restrip_mesh* mesh, uint32_t v, uint32_t left, uint32_t right,
                                                 uint32_t v_t, restrip_change* change);
RESTRIP_API restrip_status restrip_mesh_collapse_at(restrip_mesh* mesh, uint32_t v, uint32_t w, restrip_change* change);
RESTRIP_API restrip_status restrip_mesh_flip_at(restrip_mesh* mesh, uint32_t v, uint32_t w, restrip_change* change);

/* Any change of a few triangles: removes the triangles `out` and adds in_count triangles `in`, three vertices each,
 * counter-clockwise; either list may be empty. Vertices that are not in use become new ones, vertices left without
 * triangles go. Edges of removed triangles are cleared, then the policy searches among what has changed. Refused unless
 * the mesh stays a manifold with boundary, with three triangles or more around an interior vertex. `halfedge` of the
 * change is a side of the first new triangle. Quadratic in the triangles, and the time of the policy. */
RESTRIP_API restrip_status restrip_mesh_replace(restrip_mesh* mesh, const uint32_t* out, size_t out_count,
                                                const uint32_t* in, size_t in_count, restrip_change* change);

/* Four operations on few triangles, independent of valences; longest-edge bisection uses them. They are checked and
 * reported like the three above, and maintain strips like them.
 *
 * Split face: a new vertex v_t inside the triangle of h, which leaves v_s; one triangle becomes three. `halfedge` of
 * the change is v_s -> v_t. */
RESTRIP_API restrip_status restrip_mesh_split_face(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);
/* Join faces: removes v_t of h = v_s -> v_t, an interior vertex of three triangles (else RESTRIP_OTHER_PATCH), which
 * become one. `halfedge` of the change is a side of it. */
RESTRIP_API restrip_status restrip_mesh_join_faces(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);
/* Bisect: a new vertex v_t on the mesh edge of h, which leaves v_s; the triangles at it become two each. `halfedge` of
 * the change is v_s -> v_t. */
RESTRIP_API restrip_status restrip_mesh_bisect(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);
/* Merge: removes v_t of h = v_s -> v_t, an interior vertex of four triangles, or a boundary vertex of two triangles
 * with h or its opposite on the boundary (else RESTRIP_OTHER_PATCH), and joins v_s to the vertex beyond. `halfedge`
 * of the change is a side of a triangle that is left. */
RESTRIP_API restrip_status restrip_mesh_merge(restrip_mesh* mesh, restrip_halfedge h, restrip_change* change);

/* A custom operation, with the table that `restrip-generate rules` made of its file (docs/reference/operation-file.md);
 * the JSON that it writes with --language json has these numbers. Vertices are numbered from 0 in the order in which
 * the file names them, before and after together.
 *
 * Triangles are in the order of a traversal: each after the first is met from triangle `from` across its side
 * `from_side`, and its side 0 is that one. Side s runs from corner s to the next one. It is an inner edge by its
 * number, 64 + a port, or 255 on the boundary of the mesh. */
typedef struct restrip_patch_triangle {
  uint8_t from;
  uint8_t from_side;
  uint8_t vertex[3];
  uint8_t side[3];
} restrip_patch_triangle;
typedef struct restrip_operation {
  uint32_t ports;
  uint32_t edges_before; /* inner edges */
  uint32_t edges_after;
  uint32_t vertices;
  int32_t matching; /* 1: a table for matchings, which a mesh does not have */
  const restrip_patch_triangle* before;
  size_t before_count;
  const restrip_patch_triangle* after;
  size_t after_count;
  /* The entry at `inner edges << ports | ports` has the same masks after the operation; RESTRIP_NONE: not a valid
   * colouring. */
  const uint32_t* entries;
  size_t entry_count;
} restrip_operation;
typedef struct restrip_table restrip_table;
/* Copies and checks a table: its triangles, and that each rule is sound in every mesh. RESTRIP_BAD_ARGUMENT otherwise;
 * then `text` receives what is wrong, cut off after text_size - 1 bytes; it may be null with text_size 0. After an
 * error *table is null. Linear in the entries. */
RESTRIP_API restrip_status restrip_table_make(const restrip_operation* operation, char* text, size_t text_size,
                                              restrip_table** table);
/* Null is allowed. */
RESTRIP_API void restrip_table_free(restrip_table* table);
/* Does the operation, checked like the others. h is the side from the first vertex to the second of the first triangle
 * before, `halfedge` of the change the same of the first triangle after. `added` and `added_count` may be null, or
 * receive the new vertices, in the order in which the file names them; `added` has room for RESTRIP_MOST_NEW_VERTICES.
 */
#define RESTRIP_MOST_NEW_VERTICES 18
RESTRIP_API restrip_status restrip_mesh_apply(restrip_mesh* mesh, const restrip_table* table, restrip_halfedge h,
                                              restrip_change* change, uint32_t* added, size_t* added_count);

/* The operations that take one halfedge. */
enum {
  RESTRIP_COLLAPSE = 0,
  RESTRIP_FLIP = 1,
  RESTRIP_SPLIT_FACE = 2,
  RESTRIP_JOIN_FACES = 3,
  RESTRIP_BISECT = 4,
  RESTRIP_MERGE = 5
};
/* Many in one call, in the order of the halfedges. statuses[i] receives what the operation at halfedges[i] returns; a
 * refusal does not stop the others, and an earlier operation may remove the halfedge of a later one. `changes` may be
 * null; changes[i] is written only with statuses[i] == RESTRIP_OK. RESTRIP_BAD_ARGUMENT for another number of an
 * operation. */
RESTRIP_API restrip_status restrip_mesh_apply_each(restrip_mesh* mesh, int32_t operation, size_t n,
                                                   const restrip_halfedge* halfedges, restrip_status* statuses,
                                                   restrip_change* changes);
/* The statuses that the operations would return, each by itself on the mesh as it is: RESTRIP_OK if it would be done.
 */
RESTRIP_API restrip_status restrip_mesh_check_each(const restrip_mesh* mesh, int32_t operation, size_t n,
                                                   const restrip_halfedge* halfedges, restrip_status* statuses);
RESTRIP_API restrip_status restrip_mesh_check_split(const restrip_mesh* mesh, restrip_halfedge left,
                                                    restrip_halfedge right, uint32_t v_t);

/* One vertex split, by vertices: v_t is split off v_s, between v_l and v_r. On the boundary v_l or v_r is RESTRIP_NONE.
 * It makes the triangles (v_s, v_t, v_l) and (v_t, v_s, v_r). Records come from a simplifier: `restrip simplify -o
 * x.pm` writes them (docs/reference/file-formats.md), or yours, by restrip_mesh_collapse of the halfedge from v_s to
 * v_t: v_l and v_r are the apexes of the triangles to its left and right before it, and the last collapse is the first
 * record. */
typedef struct restrip_record {
  uint32_t v_s;
  uint32_t v_t;
  uint32_t v_l;
  uint32_t v_r;
} restrip_record;
/* Plays the records in their order, or, with `forward` 0, collapses them again from the last one on. Ends with the
 * status of the first that the mesh refuses, which is RESTRIP_VERTEX_IN_USE for records that are played already; `done`
 * may be null, or receives the number played. */
RESTRIP_API restrip_status restrip_mesh_play(restrip_mesh* mesh, const restrip_record* records, size_t n,
                                             int32_t forward, size_t* done);

/* Background work between operations: examines about `budget` states of searches, a few hundred nanoseconds each.
 * `saved` may be null, or receives the decrease of the cost. RESTRIP_BAD_ARGUMENT while a baked level is played, which
 * it would leave. */
RESTRIP_API restrip_status restrip_mesh_improve(restrip_mesh* mesh, size_t budget, size_t* saved);

/* ---- Strips and index buffers out -------------------------------------------------------------- */

/* The triangles of all strips, one strip after the other, each triangle once; strip s is from place starts[s] to
 * starts[s + 1] - 1. `triangles` has room for restrip_mesh_triangle_count numbers, `starts` for one more than
 * restrip_mesh_strip_count (else RESTRIP_TOO_SMALL). O(T), in the same order for equal meshes on every machine. */
RESTRIP_API restrip_status restrip_mesh_strips(const restrip_mesh* mesh, uint32_t* triangles, size_t triangles_size,
                                               size_t* starts, size_t starts_size);

/* ---- Index buffers in any form ---------------------------------------------------------------- */

/* Forms of an index buffer. */
enum {
  RESTRIP_FORM_RESTART = 0,  /* one triangle strip, restarted by the index with all bits set */
  RESTRIP_FORM_STITCHED = 1, /* one triangle strip without restart: repeated indices lead from strip to strip */
  RESTRIP_FORM_LENGTHS = 2,  /* strips one after the other, one draw call (or entry of a multi-draw) each */
  RESTRIP_FORM_LIST = 3      /* a triangle list */
};
typedef struct restrip_format {
  int32_t form;
  int32_t index_bits;   /* 16, 32, or 0: 16 when every index is below 65,535 */
  size_t most_vertices; /* different ones in a batch, at least 3; 0: no limit. Strips are cut where a batch ends */
  size_t most_indices;  /* in a batch, at least 4; 0: no limit */
  int32_t keep_strips;  /* 0: a list replaces strips if it has fewer indices; `form` of the view says so */
} restrip_format;

/* Consecutive indices of a buffer. */
typedef struct restrip_range {
  size_t first;
  size_t count;
} restrip_range;

/* The contents of a buffer. Pointers are valid as long as the buffer, or, for a live buffer, until the next non-const
 * call for its mesh. */
typedef struct restrip_buffer_view {
  const void* indices;
  size_t index_count;
  int32_t index_bits; /* 16 or 32 */
  int32_t form;
  const restrip_range* draws; /* each is one draw: batches, strips of RESTRIP_FORM_LENGTHS, or everything */
  size_t draw_count;
  size_t triangles;
} restrip_buffer_view;

/* An index buffer that does not change. */
typedef struct restrip_buffer restrip_buffer;
/* A first-in-first-out cache of transformed vertices, for which strips are cut, joined and ordered. */
typedef struct restrip_cache {
  uint32_t size; /* vertices; 16 suits most hardware; 0: no cache */
  double weight; /* indices that a miss is worth, up to 1000: more means fewer misses and more indices; 0: default */
} restrip_cache;
/* The strips of a triangle list, without a mesh: as restrip_mesh_build_u32 and restrip_mesh_stripify. `cost` may be
 * null: RESTRIP_FEWEST_INDICES; `cache` may be null: none; `format` may be null: restarts, the narrowest indices.
 * Triangles with a corner twice or out of range are left out. RESTRIP_TOO_LARGE when 16 bits are requested and do not
 * suffice, and for a vertex_count above 4,294,967,295. Vertex numbers far above the number of indices take no memory.
 * After an error *buffer is null.
 */
RESTRIP_API restrip_status restrip_strips_of_u32(const uint32_t* indices, size_t index_count, size_t vertex_count,
                                                 int32_t effort, const restrip_cost* cost, const restrip_cache* cache,
                                                 const restrip_format* format, restrip_buffer** buffer);
RESTRIP_API restrip_status restrip_strips_of_u16(const uint16_t* indices, size_t index_count, size_t vertex_count,
                                                 int32_t effort, const restrip_cost* cost, const restrip_cache* cache,
                                                 const restrip_format* format, restrip_buffer** buffer);
/* The strips of a mesh, in the order of the triangles, or cut and ordered for `cache` if it is not null; the mesh keeps
 * its strips. O(T). */
RESTRIP_API restrip_status restrip_mesh_buffer(const restrip_mesh* mesh, const restrip_cache* cache,
                                               const restrip_format* format, restrip_buffer** buffer);
RESTRIP_API restrip_status restrip_buffer_read(const restrip_buffer* buffer, restrip_buffer_view* view);
/* Null is allowed. */
RESTRIP_API void restrip_buffer_free(restrip_buffer* buffer);

/* ---- The live buffer --------------------------------------------------------------------------- */

/* An index buffer kept in step with the mesh; an update writes only the changes. It begins with the first update; a
 * mesh that is never updated has none. */

/* How it stays short, and in an order that a vertex cache likes; for strips. */
typedef struct restrip_layout {
  uint32_t cache; /* vertices of the cache, up to 64; 0: no order; default 32 */
  uint32_t
      waste; /* per mille of the indices needed that cuts and gaps may add; above it updates close gaps; default 95 */
  uint32_t work; /* indices that an update may move for each changed one, up to 100; default 5 */
} restrip_layout;
/* Begins the buffer again, in another format; the next update writes it. `format` may be null: 16 bits until a vertex
 * needs 32; limits of batches are not supported (RESTRIP_BAD_ARGUMENT), and strips stay strips. With 16 bits,
 * operations that would add a vertex above 65,534 are refused: RESTRIP_TOO_LARGE. `layout` may be null.
 *
 * Strips usually take at most 1.10 times the indices needed, and after many scattered operations, or in a grid, up to
 * 1.2 times (stitched: 1.25). A list is about twice as long, but an update of it writes less. If a draw call is limited
 * to N indices, N even, draw a stitched buffer in windows [(N - 2) i, (N - 2) i + N), cut off at its end: they overlap
 * by two indices and begin at even places, so they draw each triangle once, with its winding.
 *
 * `history` is the budget of undo, 0 for none: a frame counts the triangles that changed in it, some 50 bytes each;
 * when all frames together count more, the oldest are dropped, except the last one. O(1). */
RESTRIP_API restrip_status restrip_live_begin(restrip_mesh* mesh, const restrip_format* format,
                                              const restrip_layout* layout, size_t history);
/* Brings the buffer in step with the mesh, and ends a frame of the history. *ranges receives the ranges that may have
 * changed, ascending and disjoint, to be copied to the device, and *range_count their number. They are joined when at
 * most merge_gap indices apart (2 is a good value), and begin and end at multiples of `align` bytes: 2, or a multiple
 * of 4, as WebGPU requires. The last may end with the buffer, whose length is a multiple of four bytes. `outgrown` may
 * be null, or receives 1 when the buffer has become longer than `room` of restrip_live_buffer was, or its indices
 * wider: make a new one on the device. The only range is then the whole buffer. The ranges are valid until the next
 * update. Linear in the changes, and for RESTRIP_FORM_LENGTHS in the runs; O(T) the first time and after
 * restrip_mesh_stripify, restrip_mesh_set_colors and restrip_baked_restart. RESTRIP_TOO_LARGE when 16 bits cannot name
 * a vertex; after that and after RESTRIP_OUT_OF_MEMORY the next update writes the whole buffer. */
RESTRIP_API restrip_status restrip_live_update(restrip_mesh* mesh, size_t merge_gap, size_t align,
                                               const restrip_range** ranges, size_t* range_count, int32_t* outgrown);
/* The buffer after the last update; empty before the first. `room` may be null, or receives the number of indices that
 * the device should have room for. O(1). */
RESTRIP_API restrip_status restrip_live_buffer(const restrip_mesh* mesh, restrip_buffer_view* view, size_t* room);
/* Undoes the last frame, or redoes the next one; changes since the last update are a frame. *done receives 1, or 0 when
 * no frame is left. Triangles, numbers, halfedges, colours and baked levels are restored; the next update draws them as
 * after any change. The history begins again after restrip_baked_restart and some errors.
 * Linear in the frame; O(T) under policies that search for fewest strips. */
RESTRIP_API restrip_status restrip_live_undo(restrip_mesh* mesh, int32_t* done);
RESTRIP_API restrip_status restrip_live_redo(restrip_mesh* mesh, int32_t* done);
/* The number of frames that can be undone, and redone. O(1). */
RESTRIP_API restrip_status restrip_live_history_size(const restrip_mesh* mesh, size_t* undoable, size_t* redoable);
/* The number of frames that led to the present state; 0 without a history. For data that undo is to restore as well,
 * such as points: after restrip_live_undo it is the frame whose data is wanted. An update that ends a frame raises it.
 * O(1). */
RESTRIP_API size_t restrip_live_frame(const restrip_mesh* mesh);

/* ---- Baked meshes ------------------------------------------------------------------------------ */

/* A progressive mesh with strips precomputed by `restrip bake` for every level (docs/how-to/baked-strips.md). Level n
 * is the base with its first n records played. All functions above work on it. Other changes (split, collapse, flip,
 * stripify, keep, set_colors) leave the levels: from then on the policy maintains the strips, RESTRIP_POLICY_LOCAL
 * unless you choose another, and restrip_baked_move returns RESTRIP_OUT_OF_STEP until restrip_baked_restart. */

/* Reads the bytes of a baked mesh and returns a mesh at level 0. The bytes are copied and checked, and every record is
 * played once. RESTRIP_BAD_FILE if they are damaged, of another version, or do not describe a mesh. Then `text`
 * receives what is wrong, phrased to follow the file name and a colon, cut off after text_size - 1 bytes; it may be
 * null with text_size 0. After an error *mesh is null. O(bytes). */
RESTRIP_API restrip_status restrip_baked_read(const void* bytes, size_t size, char* text, size_t text_size,
                                              restrip_mesh** mesh);
/* The number of records, the highest level; 0 for a mesh that is not baked. */
RESTRIP_API size_t restrip_baked_levels(const restrip_mesh* mesh);
/* The level of the mesh. RESTRIP_OUT_OF_STEP when it has left its levels. */
RESTRIP_API restrip_status restrip_baked_level(const restrip_mesh* mesh, size_t* level);
/* Moves to a level, by at most `most` records (SIZE_MAX: all the way); `done` may be null, or receives the number
 * played. A record takes about twice as long as the bare mesh update. RESTRIP_BAD_ARGUMENT above the highest level.
 * After RESTRIP_OUT_OF_MEMORY the mesh has left its levels. */
RESTRIP_API restrip_status restrip_baked_move(restrip_mesh* mesh, size_t level, size_t most, size_t* done);
/* Returns to level 0 and to RESTRIP_POLICY_BAKED, from any state. O(T). */
RESTRIP_API restrip_status restrip_baked_restart(restrip_mesh* mesh);
/* Record i. RESTRIP_BAD_ARGUMENT when none exists. */
RESTRIP_API restrip_status restrip_baked_record(const restrip_mesh* mesh, size_t i, restrip_record* record);
/* The payload of record i, the same number of bytes for every record; 0 without a payload (docs/how-to/baked-strips.md,
 * "A payload"). Valid as long as the mesh. RESTRIP_BAD_ARGUMENT when the record does not exist. */
RESTRIP_API restrip_status restrip_baked_payload(const restrip_mesh* mesh, size_t i, const void** bytes, size_t* size);
/* The positions of all vertices, three coordinates each: first the base, then one vertex for each record. Valid as long
 * as the mesh. */
RESTRIP_API restrip_status restrip_baked_points(const restrip_mesh* mesh, const float** coordinates,
                                                size_t* vertex_count);

/* ---- Rules ------------------------------------------------------------------------------------- */

/* The rules by themselves, for a custom mesh: from the colours of a patch before an operation to the colours after it.
 * Masks are numbered as in docs/reference/notation.md: bit i of `colors` is inner edge i, bit i of `ports` port i. */
enum {
  /* A closed fan of k triangles, 3 <= k, is split before triangles 0 and i, 1 <= i < k: k colours become k + 3. */
  RESTRIP_RULE_SPLIT = 0,
  RESTRIP_RULE_COLLAPSE = 1, /* the inverse: k + 3 become k */
  /* An open fan, 1 <= k, two triangles in gaps i < j <= k: k - 1 colours become k + 2. */
  RESTRIP_RULE_OPEN_SPLIT = 2,
  RESTRIP_RULE_OPEN_COLLAPSE = 3,
  RESTRIP_RULE_BOUNDARY_SPLIT = 4, /* one triangle in gap i <= k: k - 1 become k */
  RESTRIP_RULE_BOUNDARY_COLLAPSE = 5,
  RESTRIP_RULE_FLIP = 6 /* two triangles, four ports counter-clockwise, the first two of one triangle: one colour */
};
typedef struct restrip_answer {
  uint64_t colors; /* the inner edges after the operation */
  uint64_t ports;  /* the ports after it: unchanged, except that a flip may clear some */
  int32_t strips;  /* change in the number of strips */
} restrip_answer;
#define RESTRIP_LARGEST_FAN 61
/* k is at most RESTRIP_LARGEST_FAN; numbers that a rule does not have are ignored. RESTRIP_BAD_ARGUMENT for a position
 * out of range, RESTRIP_BAD_COLORING for colours that no valid colouring has. Constant time up to k = 8, two steps a
 * triangle above. */
RESTRIP_API restrip_status restrip_lookup(int32_t rule, uint32_t k, uint32_t i, uint32_t j, uint64_t colors,
                                          uint64_t ports, restrip_answer* answer);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif /* RESTRIP_H */
