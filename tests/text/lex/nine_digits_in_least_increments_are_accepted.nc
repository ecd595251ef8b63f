O1 (LEX-28: 123456.789 mm are 123456789 increments)
G90 G00 X123456.789 (expect moves: rapid X123456.789)
M30
