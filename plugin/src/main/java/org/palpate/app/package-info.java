/**
 * The command line: wires everything, owns start and stop.
 *
 * <p>Uses {@code host} and {@code io}.
 */
package org.palpate.app;
