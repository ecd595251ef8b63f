O1 (LEX-26: M[3.5] is M04, S[1000.5] is S1001)
S[1000.5] M[3.]
#100=#4119 (expect #100=1001)
M[3.5]
#101=#4113 (expect #101=4)
M30
(finally records: spindle cw 1001; spindle ccw 1001)
