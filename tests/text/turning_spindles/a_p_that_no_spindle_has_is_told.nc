(run with: --machine lathe2)
O1 (Spindles)
G97S800M03P12 (expect assumed: P12 names a spindle that the machine file does not)
M30
(finally records: spindle cw 800)
