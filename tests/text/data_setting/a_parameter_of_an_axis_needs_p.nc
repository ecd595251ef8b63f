O1 (section 7.4: 5440 has a value for each axis)
G10 L50
N5440 R0.5 (expect alarm PS0231 says P is missing)
G11
M30
