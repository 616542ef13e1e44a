// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace meristem {

/// Runs a function on a thread of its own, for which nobody waits. If no thread can be started, runs nothing and
/// destroys the function at once. The function must not throw.
void run_apart(std::function<void()> function);

/// Frees an object on another thread. Freeing a document of a million components takes a second, for which a call that
/// was asked to stop must not wait. The object must own all that its destructor uses.
template <class Object>
void free_later(Object object) {
  auto held = std::make_shared<Object>(std::move(object));
  run_apart([held = std::move(held)]() mutable { held.reset(); });
}

}  // namespace meristem
