/**
 * Decodes compressed bytes, and checks compressed streams before a library reads them.
 *
 * <p>Knows no file format and uses nothing of Palpate. An instance is for one thread. Bytes.
 */
package org.palpate.io.codec;
