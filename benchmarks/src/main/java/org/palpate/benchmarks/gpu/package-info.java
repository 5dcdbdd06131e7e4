/**
 * Measures from how many points an OpenCL device judges legs faster than the CPU.
 *
 * <p>Uses {@code opencl}, {@code benchmarks.report} and {@code benchmarks.rigid}, and a phantom.
 * Starts one thread of its own, to share work between two. Times are microseconds.
 */
package org.palpate.benchmarks.gpu;
