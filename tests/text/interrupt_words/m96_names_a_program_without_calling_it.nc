O1 (section 7.3: unlike M98 it does not need the program now)
M96 P9876
#100=1 (expect #100=1)
M97
M30
