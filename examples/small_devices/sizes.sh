#!/usr/bin/env bash
# The bytes of each program beyond an empty one, and how many functions compute doubles by software.
#
# It needs `rustup target add thumbv7em-none-eabihf` and LLVM's or Arm's `size` and `nm`.
set -euo pipefail
cd "$(dirname "$0")"
cargo build --release --quiet
folder=${CARGO_TARGET_DIR:-target}/thumbv7em-none-eabihf/release

tool() {
    for prefix in llvm- rust- arm-none-eabi-; do
        if command -v "$prefix$1" > /dev/null; then
            echo "$prefix$1"
            return
        fi
    done
    echo "no $1 for Arm" >&2
    exit 1
}
size=$(tool size)
names=$(tool nm)

bytes() {
    "$size" "$folder/$1" | awk 'END { print $1 + $2 }'
}
printf '%-14s %8s %8s\n' program bytes doubles
for name in swing_single swing_double drone_single drone_double; do
    doubles=$("$names" "$folder/$name" | grep -c -E '__aeabi_d(add|sub|mul|div)|__(add|sub|mul|div)df3' || true)
    printf '%-14s %8d %8d\n' "$name" $(($(bytes "$name") - $(bytes nothing))) "$doubles"
done
