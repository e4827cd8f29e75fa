// Exceptions in WebAssembly: the part of the C++ ABI that Debian's libc++abi for wasm32 leaves out, for one thread.
//
// The engine unwinds: `throw` is an instruction with the address of an exception, and each landing pad is a `catch`.
// What is left for a library is to say which handler of a landing pad takes the exception. The compiler calls
// _Unwind_CallPersonality with the address before each landing pad that has typed handlers, after it has stored the
// number of the pad and the table of its function in __wasm_lpad_context. The answer, `selector`, is the number of the
// type in the table, or 0: then the exception propagates.
//
// The table is the language-specific data area of the Itanium C++ ABI, in the form for numbered landing pads: a row for
// each pad with its first action, a list of actions (a type, and the distance to the next action), and the types,
// backwards. No exception specifications occur.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

// The tag of all C++ exceptions: one address.
__asm__(".globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n");

namespace __cxxabiv1 {
/// The first members of libc++abi's class of the same name, whose table of functions it must match.
class __shim_type_info : public std::type_info {
 public:
  virtual ~__shim_type_info();
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown_type, void*& adjusted) const = 0;
};
}  // namespace __cxxabiv1

namespace {

/// Lies before the thrown object.
struct Header {
  const std::type_info* type = nullptr;
  void* (*destroy)(void*) = nullptr;  ///< destructors return their object here
  void* adjusted = nullptr;           ///< the object as the type of the handler
  Header* below = nullptr;            ///< caught before it and not finished yet
  int handlers = 0;                   ///< that are active
  bool again = false;                 ///< on its way again after `throw;`
};
constexpr std::size_t header_bytes = (sizeof(Header) + 15) / 16 * 16;

Header* caught = nullptr;

Header* header_of(void* object) { return reinterpret_cast<Header*>(static_cast<char*>(object) - header_bytes); }
void* object_of(Header* header) { return reinterpret_cast<char*>(header) + header_bytes; }

std::uint32_t unsigned_number(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return value;
  }
}

std::int32_t signed_number(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;;) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
    shift += 7;
    if ((byte & 0x80) != 0) continue;
    if ((byte & 0x40) != 0 && shift < 32) value |= ~std::uint32_t{0} << shift;
    return static_cast<std::int32_t>(value);
  }
}

bool takes(const std::type_info* handler, Header* header) {
  void* adjusted = object_of(header);
  if (handler != nullptr) {  // null: catch (...)
    const auto* const wanted = static_cast<const __cxxabiv1::__shim_type_info*>(handler);
    if (!wanted->can_catch(static_cast<const __cxxabiv1::__shim_type_info*>(header->type), adjusted)) return false;
  }
  header->adjusted = adjusted;
  return true;
}

/// The number of the first type of a landing pad that takes the exception; 0 if none does.
std::uint32_t selected(const std::uint8_t* table, std::uint32_t pad, Header* header) {
  constexpr std::uint8_t omitted = 0xff;
  if (*table++ != omitted) std::abort();  // landing pads are numbered, and have no addresses
  const std::uint8_t type_form = *table++;
  const std::uint8_t* types = nullptr;
  if (type_form != omitted) {
    if (type_form != 0) std::abort();  // types are addresses
    const std::uint32_t distance = unsigned_number(table);
    types = table + distance;
  }
  ++table;  // the form of the rows, which are always numbers of variable length
  const std::uint32_t row_bytes = unsigned_number(table);
  const std::uint8_t* const actions = table + row_bytes;
  for (const std::uint8_t* row = table; row < actions;) {
    const std::uint32_t number = unsigned_number(row);
    const std::uint32_t first_action = unsigned_number(row);
    if (number != pad) continue;
    if (first_action == 0) return 0;
    for (const std::uint8_t* action = actions + first_action - 1;;) {
      const std::int32_t type = signed_number(action);
      const std::uint8_t* const here = action;
      const std::int32_t next = signed_number(action);
      if (type < 0) std::abort();
      if (type > 0) {
        const auto* const place = reinterpret_cast<const std::type_info* const*>(types) - type;
        if (takes(*place, header)) return static_cast<std::uint32_t>(type);
      }
      if (next == 0) return 0;
      action = here + next;
    }
  }
  std::abort();
}

[[noreturn]] void raise(Header* header) { __builtin_wasm_throw(0, object_of(header)); }

}  // namespace

extern "C" {

struct LandingPadContext {
  std::uint32_t pad;
  const std::uint8_t* table;
  std::uint32_t selector;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* object) {
  __wasm_lpad_context.selector = selected(__wasm_lpad_context.table, __wasm_lpad_context.pad, header_of(object));
  return 0;
}

/// Tables name it; nothing calls it.
void __gxx_wasm_personality_v0() { std::abort(); }

void* __cxa_allocate_exception(std::size_t bytes) noexcept {
  void* const memory = std::malloc(header_bytes + bytes);
  if (memory == nullptr) std::abort();
  return object_of(new (memory) Header);
}

void __cxa_free_exception(void* object) noexcept { std::free(header_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Header* const header = header_of(object);
  header->type = type;
  header->destroy = destroy;
  header->adjusted = object;
  raise(header);
}

void* __cxa_get_exception_ptr(void* object) noexcept { return header_of(object)->adjusted; }

void* __cxa_begin_catch(void* object) noexcept {
  Header* const header = header_of(object);
  if (header->again)
    header->again = false;  // it is on the list already
  else {
    header->below = caught;
    caught = header;
  }
  ++header->handlers;
  return header->adjusted;
}

void __cxa_end_catch() {
  Header* const header = caught;
  if (header == nullptr || --header->handlers > 0 || header->again) return;
  caught = header->below;
  if (header->destroy != nullptr) header->destroy(object_of(header));
  std::free(header);
}

[[noreturn]] void __cxa_rethrow() {
  if (caught == nullptr) std::terminate();
  caught->again = true;
  raise(caught);
}

}  // extern "C"
