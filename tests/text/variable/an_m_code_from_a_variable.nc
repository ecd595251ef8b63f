O1 (VAR-6: M#13 with 3)
#13=3
S200 M#13
M30
(finally records: spindle cw 200)
