# Puts built pages (FROM, of the sources in WEB) into the folder TO, with the hash of what they are made of.
include(${CMAKE_CURRENT_LIST_DIR}/page_sources.cmake)
hash_of_page_sources(${WEB} hash)
file(COPY ${FROM}/page.html ${FROM}/study.html DESTINATION ${TO})
file(WRITE ${TO}/sources.sha256 "${hash}\n")
