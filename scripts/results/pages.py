def update(root, choices, check=False):
    return 0
