/**
 * Command-line options that several commands share, and the volume, device, settings and output
 * paths that they stand for.
 *
 * <p>Uses {@code app.process}, {@code host} and {@code io}. One thread. World millimetres.
 */
package org.palpate.app.options;
