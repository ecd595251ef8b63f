O1 (section 3.3: #5061 after a G31 that met nothing)
G90 G31 X10. F50 (expect moves: probe X10)
#100=#5061 (expect #100=10)
M30
