/**
 * Tests of the guarantee over whole sessions on phantoms and scans, and under attack by hostile
 * scenes and hands, decided exactly.
 *
 * <p>Uses {@code host}, as a session does, the oracle of {@code testing}, and the attack of {@code
 * benchmarks.stress}. Grid coordinates.
 */
package org.palpate.guarantee;
