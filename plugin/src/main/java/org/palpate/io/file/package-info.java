/**
 * Replaces files atomically, claims them for one process, and parses and formats numbers.
 *
 * <p>Uses nothing of Palpate. Static methods are for any thread, an instance is for one. No units.
 */
package org.palpate.io.file;
