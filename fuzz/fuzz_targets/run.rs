// Shared by the targets under libFuzzer; each sets its name and includes this file.
use std::path::Path;
use std::sync::LazyLock;

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use targets::Target;
use targets::mutate::{Rng, mutate};

static TARGET: LazyLock<Target> = LazyLock::new(|| targets::find(NAME));

fuzz_target!(
    init: {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the fuzz crate is in the repository");
        targets::write_seeds(&TARGET, root);
    },
    |bytes: &[u8]| (TARGET.run)(bytes)
);

// Half of the changes keep the structure of the input, half come from libFuzzer.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let mut rng = Rng::new(seed.into());
    if rng.once_in(2) {
        return fuzzer_mutate(data, size, max_size);
    }
    let mut changed = data[..size].to_vec();
    mutate(&mut changed, max_size, &mut rng);
    data[..changed.len()].copy_from_slice(&changed);
    changed.len()
});
