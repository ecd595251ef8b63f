(run with: --machine lathe3c)
O1 (Spindles)
G97S6000M03 (expect assumed: S6000 is more than the main spindle can: it turns with 4500 rpm)
S6500M133
S5500M143
M30
(finally records: spindle cw 4500; live spindle cw 6000; sub spindle cw 5000)
