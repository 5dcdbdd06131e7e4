/**
 * Reads files without a header, whose layout the user gives.
 *
 * <p>Uses {@code io.format} and {@code io.volume}. An instance is for one thread. Spacing in
 * millimetres; the patient's axes are unknown.
 */
package org.palpate.io.raw;
