// Non-owning reference to a callable, like C++26's std::function_ref: for parameters that are called often
// and not stored. The callable must outlive it, so it must not be used for variables.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace hawser {

template <class Signature>
class FunctionRef;

template <class Result, class... Args>
class FunctionRef<Result(Args...)> {
 public:
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef> && std::is_invocable_r_v<Result, F&, Args...>)
      FunctionRef(F&& f)
      : called_(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call_([](void* called, Args... args) -> Result {
          return (*static_cast<std::remove_reference_t<F>*>(called))(std::forward<Args>(args)...);
        }) {}

  Result operator()(Args... args) const { return call_(called_, std::forward<Args>(args)...); }

 private:
  void* called_;
  Result (*call_)(void*, Args...);
};

}  // namespace hawser
