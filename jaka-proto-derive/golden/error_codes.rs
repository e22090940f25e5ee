impl ::jaka_proto::ErrorCode {
    pub const REJECTED: Self = Self(-1i64);
    pub const SUCCESS: Self = Self(0i64);
    pub const EXCEPTION: Self = Self(1i64);
    pub const CALL_FAILED: Self = Self(2i64);
    pub const PERMISSION_DENIED: Self = Self(3i64);
    pub fn meaning(self) -> Option<&'static str> {}
}
