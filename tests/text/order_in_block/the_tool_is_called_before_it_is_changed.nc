O1 (section 8: T before M06)
M06 T8
M30
(finally records: tool 8)
