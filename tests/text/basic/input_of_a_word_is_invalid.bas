' (with input: 5, abc)
input a
input b ' (expect alarm LB0025 says abc)
