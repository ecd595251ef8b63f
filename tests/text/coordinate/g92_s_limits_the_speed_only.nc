O1 (G92 S is the highest speed of G96, not a speed)
M03 S500
G92 S2000
#100=#4119 (expect #100=500)
G96 S100
M30
(finally records: spindle cw 500; spindle cw 100)
