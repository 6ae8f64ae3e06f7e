#!/bin/sh
# usage_test.sh PROGRAM ROOT SCRATCH
# Wrong words end with code 2 and a sentence that fits a terminal, and leave no file behind.
set -eu
program=$1 root=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch/out"
cd "$scratch/out"

wrong() { echo "WRONG: $1" >&2; cat "$scratch/said" >&2; exit 1; }
refuses() {
  code=0
  CS550_ROOT=$root "$program" "$@" >"$scratch/said" 2>&1 </dev/null || code=$?
  [ $code = 2 ] || wrong "'$*' ended with code $code, should be 2"
  [ -s "$scratch/said" ] || wrong "'$*' said nothing"
  ! grep -qE '^.{81}' "$scratch/said" || wrong "'$*' said a line of more than 80 columns"
  [ -z "$(ls -A .)" ] || wrong "'$*' left $(ls -A .)"
}
says() { grep -qF "$1" "$scratch/said" || wrong "should say: $1"; }

refuses lab
refuses lab three
says "there is no lab three"
says "Lab 1: integration"
refuses lab 99
says "Lab 1: integration"
refuses lab 3 --step L4.1
says "L3.1"
refuses lab 3 --hint 9
refuses lab 3 --reset --run
refuses lab 3 --asan --debug
refuses submit three
says "Lab 1: integration"
refuses submit 0
says "Lab 1: integration"
refuses submit 3 --out .
says "is a folder"
refuses submit 3 --out absent/lab3.zip
says "there is no folder"
refuses starter
refuses starter --release-solutions many copy
refuses progress --lsit
echo "every wrong word is refused"
rm -rf "$scratch"
