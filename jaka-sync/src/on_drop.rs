//! End of a scope.

/// Calls a function when it is dropped, also by a panic.
#[derive(Debug)]
#[must_use = "the function is called when this is dropped"]
pub struct OnDrop<F: Fn()>(pub F);

impl<F: Fn()> Drop for OnDrop<F> {
    fn drop(&mut self) {
        (self.0)();
    }
}
