/**
 * Measures from how many points an OpenCL device judges legs faster than the CPU.
 *
 * <p>Uses {@code opencl}, {@code benchmarks.report}, {@code benchmarks.rigid} and phantoms. Starts
 * one thread of its own, to share work between two. Times are microseconds.
 */
package org.palpate.benchmarks.gpu;
