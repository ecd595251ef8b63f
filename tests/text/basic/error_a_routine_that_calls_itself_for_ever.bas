s: gosub s ' (expect alarm LB0012 column 4 says too many nested GOSUBs)
