O1 (section 3.1: #1133 is a word of 32 bits)
#1133=70000
#100=#1133 (expect #100=70000)
M30
