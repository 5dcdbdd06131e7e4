/**
 * The guarantee, over whole sessions on phantoms and scans, decided in rational arithmetic.
 *
 * <p>Uses {@code host}, as a session does, and the oracle of {@code testing}. Grid coordinates.
 */
package org.palpate.guarantee;
