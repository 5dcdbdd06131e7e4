/**
 * The tool of many points as the paper of 2013 has it, a baseline for rigid tools. It does not keep
 * the collision guarantee of a rigid body.
 *
 * <p>Uses {@code proxy} and {@code collision}. The calling thread takes a share of the work and
 * waits for a fixed pool of helpers. Grid coordinates.
 */
package org.palpate.benchmarks.shell;
