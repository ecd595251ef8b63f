O1 (M05 M09 at the end of a tool)
S100 M03
M08
M09 M60
M30
(finally records: spindle cw 100; coolant flood; coolant off; mcode 60)
