/**
 * Builds segments from label values or thresholds, names and colours them, and proposes labels or
 * thresholds for a volume.
 *
 * <p>Uses {@code io.format}, {@code io.volume}, {@code io.file} and {@code volume}. An instance is
 * for one thread. Values are in the file's unit, after slope and intercept.
 */
package org.palpate.io.label;
