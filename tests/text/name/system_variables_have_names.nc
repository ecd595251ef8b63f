O1 (section 3.3: positions by name)
G90 G00 X3. Y4.
#100=[#_ABSIO[1]] (expect #100=3)
#101=[#_ABSMT[2]] (expect #101=4)
M30
