/**
 * Reads trajectories, and writes frames, legs, landmarks and JSON reports.
 *
 * <p>Uses {@code io.file}. An instance is for one thread. Distances in millimetres and times in
 * milliseconds, unless the name of a column says otherwise.
 */
package org.palpate.io.table;
