O1 (section 8: S before M03)
M03 S1200
M30
(finally records: spindle cw 1200)
