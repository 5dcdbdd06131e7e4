/**
 * Counts the work that frames do and skip.
 *
 * <p>Uses the JDK alone. Stands below {@code raycast}, {@code collision} and {@code proxy}, because
 * all three report into the same counters. Belongs to the haptic thread.
 */
package org.palpate.statistics;
