"""Validates a value against a JSON Schema, for the keywords that the schemas in docs/ use."""
import re

KINDS = {"object": dict, "array": list, "integer": int, "string": str, "boolean": bool}
ANNOTATIONS = {"$schema", "$id", "$defs", "title", "description", "default"}


def fits(schema, value, whole):
    """True if the value fits the schema; `whole` is the schema with the definitions."""
    for word, argument in schema.items():
        if word in ANNOTATIONS:
            continue
        if not WORDS[word](argument, value, schema, whole):  # an unknown word is an error
            return False
    return True


def is_kind(name, value):
    return isinstance(value, KINDS[name]) and (name == "boolean" or not isinstance(value, bool))


WORDS = {
    "$ref": lambda path, value, schema, whole: fits(whole["$defs"][path.removeprefix("#/$defs/")], value, whole),
    "anyOf": lambda ways, value, schema, whole: any(fits(way, value, whole) for way in ways),
    "type": lambda name, value, schema, whole: is_kind(name, value),
    "const": lambda constant, value, schema, whole: type(value) is type(constant) and value == constant,
    "enum": lambda values, value, schema, whole: value in values,
    "minimum": lambda bound, value, schema, whole: not is_kind("integer", value) or value >= bound,
    "maximum": lambda bound, value, schema, whole: not is_kind("integer", value) or value <= bound,
    "pattern": lambda pattern, value, schema, whole: not isinstance(value, str) or re.search(pattern, value) is not None,
    "maxLength": lambda bound, value, schema, whole: not isinstance(value, str) or len(value) <= bound,
    "minItems": lambda bound, value, schema, whole: not isinstance(value, list) or len(value) >= bound,
    "maxItems": lambda bound, value, schema, whole: not isinstance(value, list) or len(value) <= bound,
    "uniqueItems": lambda wanted, value, schema, whole: not isinstance(value, list) or len(set(map(str, value))) == len(value),
    "items": lambda items, value, schema, whole: not isinstance(value, list) or all(fits(items, item, whole) for item in value),
    "prefixItems": lambda items, value, schema, whole: not isinstance(value, list)
    or all(fits(item, one, whole) for item, one in zip(items, value)),
    "required": lambda names, value, schema, whole: not isinstance(value, dict) or all(name in value for name in names),
    "properties": lambda members, value, schema, whole: not isinstance(value, dict)
    or all(fits(members[name], member, whole) for name, member in value.items() if name in members),
    "additionalProperties": lambda more, value, schema, whole: not isinstance(value, dict)
    or all(name in schema["properties"] for name in value),
}
