/** The hand-over under jcstress, by {@code mvn -Pjcstress}; uses {@code sync} alone. */
package org.palpate.sync;
