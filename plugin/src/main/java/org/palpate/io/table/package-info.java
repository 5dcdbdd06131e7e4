/**
 * Reads trajectories, and writes frames, legs, landmarks and JSON reports.
 *
 * <p>Uses {@code io.file}, {@code body}, {@code edit} and {@code elastic}. An instance is for one
 * thread. Distances in millimetres and times in milliseconds, unless the name of a column says
 * otherwise.
 */
package org.palpate.io.table;
