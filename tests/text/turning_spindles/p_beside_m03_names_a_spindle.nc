(run with: --machine lathe3c)
O1 (Spindles)
G97S800M03P12 (expect assumed: P12 is the live spindle)
M05P12
M03P1S500
M143S700
M30
(finally records: live spindle cw 800; live spindle stop; spindle cw 500; sub spindle cw 700)
