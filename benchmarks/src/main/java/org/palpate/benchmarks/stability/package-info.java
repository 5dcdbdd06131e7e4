/**
 * Person, device and contact as one closed loop in simulation: how stiff a surface may be before
 * the hand shakes, beside the theory.
 *
 * <p>Uses {@code interaction} for the frame that a session runs, and an ODE library for what
 * happens between frames. One thread. SI units inside the plant (m, kg, N, s), grid coordinates at
 * its device. Every claim is about the model.
 */
package org.palpate.benchmarks.stability;
