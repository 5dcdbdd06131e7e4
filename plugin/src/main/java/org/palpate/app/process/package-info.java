/**
 * The process around a command: user errors, exit codes, shutdown, terminal, version, and a virtual
 * display.
 *
 * <p>Uses {@code io.file}, {@code io.volume} and {@code display}. Any thread. No units.
 */
package org.palpate.app.process;
