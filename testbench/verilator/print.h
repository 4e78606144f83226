#pragma once
/// What a Verilated model prints goes to the bench (bench_runtime.cpp).
int kagesen_print(const char* format, ...);
