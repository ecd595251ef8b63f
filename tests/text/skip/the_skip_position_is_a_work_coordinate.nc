(run with: --skip-at X=105)
O1 (section 3.3: the signal comes at machine 105, that is 5 in G54)
#5221=100.
G90 G00 X0
G31 X20. F50 (expect moves: probe X105)
#100=#5061 (expect #100=5)
M30
