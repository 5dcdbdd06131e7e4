/**
 * The command of SciJava and Fiji's search bar that replays a trajectory.
 *
 * <p>Uses {@code app}. It is a package of its own because it alone may use SciJava. SciJava's
 * command thread. World millimetres.
 */
package org.palpate.scijava;
