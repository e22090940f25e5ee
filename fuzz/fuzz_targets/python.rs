#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| jaka_fuzz_targets::python(data));
