O1 (NUM-16: 2.6 behind M is M03)
#1=2.6
S100 M#1
#100=#4113 (expect #100=3)
M30
(finally records: spindle cw 100)
