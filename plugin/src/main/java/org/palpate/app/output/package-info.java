/**
 * Files that commands write: the JSON report and the tables of frames and legs.
 *
 * <p>Uses {@code app.options}, {@code host} and {@code io}. One thread an instance. Units are in
 * the names of columns and keys.
 */
package org.palpate.app.output;
