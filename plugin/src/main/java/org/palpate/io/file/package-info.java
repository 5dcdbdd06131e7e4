/**
 * Replaces files atomically, and reads and formats numbers in text.
 *
 * <p>Uses nothing of Palpate. Static methods are for any thread; an instance is for one. No units.
 */
package org.palpate.io.file;
