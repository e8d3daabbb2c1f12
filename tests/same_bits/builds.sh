#!/usr/bin/env bash
# Builds of every kind, each held against what is on record: optimized or not, with other features, for other processors; and in valgrind,
# which hides AVX-512.
set -euo pipefail
cd "$(dirname "$0")/../.."

target=${CARGO_TARGET_DIR:-target}/same_bits
build() {
    printf '\n== %s\n' "$1"
    env CARGO_TARGET_DIR="$target/$1" "${@:2}"
}
test=(cargo test --quiet -p newton-euler-same-bits)

build debug "${test[@]}"
build plain "${test[@]}" --no-default-features
build threads "${test[@]}" --features rayon
build release "${test[@]}" --release --features whole
build size CARGO_PROFILE_RELEASE_OPT_LEVEL=s "${test[@]}" --release --features whole
build link-time CARGO_PROFILE_RELEASE_LTO=fat CARGO_PROFILE_RELEASE_CODEGEN_UNITS=1 "${test[@]}" --release --features whole
build native RUSTFLAGS="-C target-cpu=native" "${test[@]}" --release --features whole
build native-plain RUSTFLAGS="-C target-cpu=native" "${test[@]}" --release --no-default-features
build v3 RUSTFLAGS="-C target-cpu=x86-64-v3" "${test[@]}" --release --features whole

# one for AVX2 has moves between registers that valgrind 3.19 does not know
for name in debug release; do
    printf '\n== %s in valgrind\n' "$name"
    program=$(find "$target/$name" -path '*/deps/same_bits-*' -type f -executable)
    valgrind --quiet --error-exitcode=1 "$program" --quiet --test-threads=1
done
