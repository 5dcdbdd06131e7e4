/**
 * Files that commands write: the JSON report, the tables of frames and legs, the recorded
 * trajectory.
 *
 * <p>Uses {@code app.options}, {@code host} and {@code io}. One thread an instance; a recording
 * reads what the haptic thread hands over. Units are in the names of columns and keys.
 */
package org.palpate.app.output;
