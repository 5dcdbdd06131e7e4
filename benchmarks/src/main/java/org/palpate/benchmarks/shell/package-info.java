/**
 * The tool of many points of the paper of 2013, a baseline for rigid tools. It does not keep the
 * collision guarantee of a rigid body.
 *
 * <p>Uses {@code proxy} and {@code collision}. The calling thread works on a range of points and
 * waits for a fixed pool of workers. Grid coordinates.
 */
package org.palpate.benchmarks.shell;
