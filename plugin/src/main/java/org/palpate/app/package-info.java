/**
 * Starts the program, finds the command that the user asks for, and turns a failure into one line
 * and an exit code.
 *
 * <p>Uses {@code app.command}, {@code app.options} and {@code app.process}. Runs on the main thread
 * of the process. No units.
 */
package org.palpate.app;
