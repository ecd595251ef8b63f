O1 (section 3.2: #44xx)
G91
#100=#4403 (expect #100=91)
M30
