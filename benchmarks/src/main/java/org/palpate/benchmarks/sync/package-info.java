/**
 * The experiment of the paper's section 5.2: what it costs the haptic thread to change the scene,
 * by three ways.
 *
 * <p>Uses the whole chain. Its haptic loop runs on the thread that asks, the scene draws on its
 * own.
 */
package org.palpate.benchmarks.sync;
