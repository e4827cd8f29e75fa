// Tokens that are altered when a program starts: tokens.py writes a header with all of its tokens like this, so that it
// is compiled once for all. Where a compiler evaluates a token it is not altered; such mutants are compiled one by one.
//
//   15U          (altered(7) ? 16U : 15U)
//   a + b        a + Token<7>{} + b         of the same precedence, so that the operands stay what they are
//   a += b       a += Token<7>{} += b
//   ~a           Inverse<7>{}->*a
//   a ? b : c    a || altered(7) ? b : c
#pragma once

#include <cstdint>
#include <cstdlib>
#include <type_traits>

#undef UINT32_C
#define UINT32_C(number) static_cast<std::uint32_t>(number)

namespace restrip_tokens {

inline const int which = std::getenv("RESTRIP_TOKEN") != nullptr ? std::atoi(std::getenv("RESTRIP_TOKEN")) : -1;

constexpr bool altered(int number) noexcept { return std::is_constant_evaluated() ? false : which == number; }

template <int N>
struct Token {};

/// A token with its left operand, or with its right one where that is read first.
template <int N, class Operand>
struct Half {
  Operand operand;
};

#define RESTRIP_BINARY(OLD, NEW)                                                         \
  template <class A, int N>                                                              \
  constexpr auto operator OLD(const A& a, Token<N>) noexcept {                           \
    return Half<N, std::decay_t<A>>{a};                                                  \
  }                                                                                      \
  template <int N, class A, class B>                                                     \
  constexpr auto operator OLD(const Half<N, A>& a, const B& b) noexcept {                \
    if constexpr (requires { static_cast<decltype(a.operand OLD b)>(a.operand NEW b); }) \
      if (altered(N)) return static_cast<decltype(a.operand OLD b)>(a.operand NEW b);    \
    return a.operand OLD b;                                                              \
  }
RESTRIP_BINARY(<, <=)
RESTRIP_BINARY(<=, <)
RESTRIP_BINARY(>, >=)
RESTRIP_BINARY(>=, >)
RESTRIP_BINARY(==, !=)
RESTRIP_BINARY(!=, ==)
RESTRIP_BINARY(+, -)
RESTRIP_BINARY(-, +)
RESTRIP_BINARY(*, +)
RESTRIP_BINARY(/, *)
RESTRIP_BINARY(%, /)
RESTRIP_BINARY(&, |)
RESTRIP_BINARY(|, &)
RESTRIP_BINARY(^, |)
RESTRIP_BINARY(<<, >>)
RESTRIP_BINARY(>>, <<)
RESTRIP_BINARY(&&, ||)  // without a short cut: only where the right operand may always be evaluated
RESTRIP_BINARY(||, &&)

#define RESTRIP_ASSIGNING(OLD, NEW)                               \
  template <int N, class B>                                       \
  constexpr auto operator OLD(Token<N>, const B& b) noexcept {    \
    return Half<N, B>{b};                                         \
  }                                                               \
  template <class A, int N, class B>                              \
  constexpr A& operator OLD(A& a, const Half<N, B>& b) noexcept { \
    if (altered(N))                                               \
      a NEW b.operand;                                            \
    else                                                          \
      a OLD b.operand;                                            \
    return a;                                                     \
  }
RESTRIP_ASSIGNING(+=, -=)
RESTRIP_ASSIGNING(-=, +=)
RESTRIP_ASSIGNING(&=, |=)
RESTRIP_ASSIGNING(|=, &=)
RESTRIP_ASSIGNING(^=, |=)

#define RESTRIP_UNARY(NAME, OLD)                                 \
  template <int N>                                               \
  struct NAME {};                                                \
  template <int N, class A>                                      \
  constexpr auto operator->*(NAME<N>, const A& a) noexcept {     \
    return altered(N) ? static_cast<decltype(OLD a)>(a) : OLD a; \
  }
RESTRIP_UNARY(Not, !)
RESTRIP_UNARY(Inverse, ~)
RESTRIP_UNARY(Minus, -)

}  // namespace restrip_tokens
